#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "render/lens/lens_library.h"
#include "render/lens/lens_sight.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_poses.h"
#include "render/parts/draw_list.h"
#include "render/parts/picture_pyramid.h"
#include "render/recent_views.h"

namespace synthetic_dataset::render {

/// Whether see-through surfaces are seen, or what is behind them.
enum class Glass { kSeen, kSeenThrough };

/// Looks at the items through lenses with distortion, without OpenGL. Items that never move are
/// looked at only once from each pose.
class LensEye {
 public:
  /// The references have to outlive this.
  /// @param keeps  whether results are kept from look to look
  LensEye(const DrawList& draw_list, LensLibrary& lenses, bool keeps);

  /// Finds what each pixel's ray sees. With Glass::kSeen, that is what labels show.
  [[nodiscard]] std::shared_ptr<const LensSight> look(const View& view,
                                                      const std::vector<Pose>& X_WL,
                                                      const LinkSelection& drawn, Glass glass);

  /// Finds what is seen in a picture whose rows are taken one after the other.
  [[nodiscard]] std::shared_ptr<const LensSight> look(const RollingView& rolling,
                                                      const LinkSelection& drawn, Glass glass);

  /// CV_8UC1: 255 for the pixels whose rays would meet these items if there were no others.
  [[nodiscard]] cv::Mat covered(const View& view, const std::vector<Pose>& X_WL,
                                const std::vector<const DrawItem*>& covering);

  /// The covered pixels of a picture whose rows are taken one after the other.
  /// @param poses  of `rows`, for at least the items' links
  [[nodiscard]] cv::Mat covered(const RollingView& rows, const RowPoses& poses,
                                const std::vector<const DrawItem*>& covering);

  /// Forgets everything that is kept, as the look has changed.
  void forget();

 private:
  /// What the rays of a view see of what never moves.
  struct Standing {
    std::shared_ptr<const LensMap> lens;
    Eigen::Matrix4d X_WC;
    LinkSelection drawn;
    bool comes_back;  ///< whether the view recurs
    RaySights sights;
    LensSight sight;
  };
  /// The last look.
  struct Last {
    Eigen::Matrix4d X_WC;
    std::vector<Eigen::Matrix4d> X_WL;
    LinkSelection drawn;
    Glass glass;
    std::shared_ptr<const LensSight> sight;
  };

  /// The last look whose rows have times of their own.
  struct LastInRows {
    std::shared_ptr<const LensMap> lens;
    std::vector<double> rows;
    std::vector<Eigen::Matrix4d> poses;  ///< at each of `rows`, the camera's and the links'
    LinkSelection drawn;
    Glass glass;
    std::shared_ptr<const LensSight> sight;

    [[nodiscard]] bool isAs(const LastInRows& other) const {
      return lens == other.lens && rows == other.rows && drawn == other.drawn &&
             glass == other.glass && poses == other.poses;
    }
  };

  /// The rays of a lens, row by row.
  struct RowGrids {
    std::shared_ptr<const LensMap> lens;
    std::vector<RowRayGrid> grids;
  };

  [[nodiscard]] const std::shared_ptr<const std::vector<ItemSurface>>& surfaces();
  [[nodiscard]] const std::vector<RowRayGrid>& rowGrids(const std::shared_ptr<const LensMap>& lens);
  [[nodiscard]] LensSight nothingSeen(const std::shared_ptr<const LensMap>& lens);
  [[nodiscard]] std::vector<Pose> posesOfItems(const Pose& X_CW,
                                               const std::vector<Pose>& X_WL) const;
  void makeRoomFor(const View& view, bool comes_back);
  [[nodiscard]] const Standing& standing(const View& view, const std::vector<Pose>& X_WL,
                                         const LinkSelection& drawn);

  const DrawList& draw_list_;
  LensLibrary& lenses_;
  bool keeps_;
  PyramidLibrary pyramids_;
  std::shared_ptr<const std::vector<ItemSurface>> surfaces_;  ///< null until needed
  std::deque<Standing> standing_;                             ///< the most recently used first
  RecentViews recent_;  ///< views that were not found in standing_
  std::optional<Last> last_;
  std::optional<LastInRows> last_in_rows_;
  RowGrids row_grids_;  ///< of the most recently used lens
};

}  // namespace synthetic_dataset::render

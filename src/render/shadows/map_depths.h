#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Some texels of a shadow map, with casters that move.
struct MapPiece {
  cv::Rect texels;
  cv::Mat depths;  ///< CV_32FC1: of the casters nearest to the light, at least of those that move
};

/// The depths of a shadow map as they were for one picture; used to finish the picture in any
/// thread.
///
/// What never moves is the same in all pictures, and what moves is small. The latter is put onto
/// one common map that is shared by all pictures, so that it stays in the CPU's cache, and pictures
/// that wait take little memory.
class MapDepths {
 public:
  /// A complete map, ready for use; it is locked for others as long as this object exists.
  class Assembled {
   public:
    /// CV_32FC1, a square.
    [[nodiscard]] const cv::Mat& depths() const { return depths_; }

    /// CV_32FC1: the least depth of each cell of kCell x kCell texels; empty if not requested.
    [[nodiscard]] const cv::Mat& nearest() const { return nearest_; }

   private:
    friend class MapDepths;

    std::unique_lock<std::mutex> lock_;
    cv::Mat depths_;
    cv::Mat nearest_;
  };

  static constexpr int kCell = 4;  ///< [texel] of a cell's side

  /// The part that several maps have in common: what never moves.
  class Standing {
   public:
    /// @param depths  CV_32FC1, a square
    explicit Standing(cv::Mat depths) : depths_(std::move(depths)), common_(depths_) {}

    /// The depths of what never moves; valid only before the first map is assembled, or after
    /// keep().
    [[nodiscard]] const cv::Mat& depths() const { return depths_; }

    /// To be called before further maps share this object. As long as there is only one map, no
    /// copy is needed.
    void keep();

   private:
    friend class MapDepths;

    [[nodiscard]] bool isKept() const { return common_.data != depths_.data; }
    void putOn(const std::vector<MapPiece>& pieces);
    void remove();
    void findNearest();

    cv::Mat depths_;
    std::mutex mutex_;  ///< for the following, and for depths_ until they are kept
    cv::Mat common_;
    cv::Mat nearest_;                ///< of the common map; empty until requested
    std::vector<MapPiece> beneath_;  ///< where pieces are on the common map, and what was there
  };

  explicit MapDepths(std::shared_ptr<Standing> standing, std::vector<MapPiece> pieces = {})
      : standing_(std::move(standing)), pieces_(std::move(pieces)) {}

  /// @param with_nearest  whether Assembled::nearest() is requested
  [[nodiscard]] Assembled assemble(bool with_nearest = false) const;

 private:
  std::shared_ptr<Standing> standing_;
  std::vector<MapPiece> pieces_;
};

}  // namespace synthetic_dataset::render

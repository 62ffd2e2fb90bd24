#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Some texels of a shadow map, with what moves.
struct MapPiece {
  cv::Rect texels;
  cv::Mat depths;  ///< CV_32FC1: of what is nearest to the light, of what moves at least
};

/// The depths of a shadow map as they were for one picture; used to finish it in any thread.
///
/// What never moves is the same in all pictures, and what moves is small. It is put onto one
/// common map, the same from picture to picture, so that what a processor looks up stays in its
/// cache, and waiting pictures take little memory.
class MapDepths {
 public:
  /// A map that looks as it is used: nobody else's as long as this lives.
  class Assembled {
   public:
    /// CV_32FC1, a square.
    [[nodiscard]] const cv::Mat& depths() const { return depths_; }

    /// CV_32FC1: the least depth of each cell of kCell x kCell texels; empty if not asked for.
    [[nodiscard]] const cv::Mat& nearest() const { return nearest_; }

   private:
    friend class MapDepths;

    std::unique_lock<std::mutex> lock_;
    cv::Mat depths_;
    cv::Mat nearest_;
  };

  static constexpr int kCell = 4;  ///< [texel] of a cell's side

  /// What several maps have in common.
  class Standing {
   public:
    /// @param depths  CV_32FC1, a square
    explicit Standing(cv::Mat depths) : depths_(std::move(depths)), common_(depths_) {}

    /// Of what never moves; only before the first map is assembled, or once it is kept.
    [[nodiscard]] const cv::Mat& depths() const { return depths_; }

    /// To be called when further maps have this in common. A map that is the only one needs no
    /// copy.
    void keep();

   private:
    friend class MapDepths;

    [[nodiscard]] bool isKept() const { return common_.data != depths_.data; }
    void putOn(const std::vector<MapPiece>& pieces);
    void remove();
    void findNearest();

    cv::Mat depths_;
    std::mutex mutex_;  ///< of the following, and of depths_ until they are kept
    cv::Mat common_;
    cv::Mat nearest_;                ///< of the common map; empty until it is asked for
    std::vector<MapPiece> beneath_;  ///< where pieces lie on the common map, and what was there
  };

  explicit MapDepths(std::shared_ptr<Standing> standing, std::vector<MapPiece> pieces = {})
      : standing_(std::move(standing)), pieces_(std::move(pieces)) {}

  /// @param with_nearest  whether those are asked for
  [[nodiscard]] Assembled assemble(bool with_nearest = false) const;

 private:
  std::shared_ptr<Standing> standing_;
  std::vector<MapPiece> pieces_;
};

}  // namespace synthetic_dataset::render

#include "core/frame_progress.h"

#include <fmt/format.h>

namespace blossom {

Progress progressOfFrame(const Progress& whole, std::size_t frame, std::size_t count) {
  return Progress(whole.token(), [whole, frame, count](double fraction, const std::string& stage) {
    const std::string at = fmt::format("frame {} of {}", frame + 1, count);
    whole.report((static_cast<double>(frame) + fraction) / static_cast<double>(count),
                 stage.empty() ? at : at + ", " + stage);
  });
}

}  // namespace blossom

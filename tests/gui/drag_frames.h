#pragma once
#include <functional>
#include <vector>

#include "ui/view/view_widget.h"

namespace blossom::test {

/// How long frames on the screen took, one after the other, while the mouse moved every 8 ms.
class DragFrames {
 public:
  /// @param move is called with the number of the movement, from 1 on
  DragFrames(ui::ViewWidget&, int moves, const std::function<void(int)>& move);

  [[nodiscard]] std::size_t count() const { return milliseconds_.size(); }
  /// Percent of the frames that came within so many milliseconds.
  [[nodiscard]] double shareWithin(double milliseconds) const;
  /// In which so many percent of the frames came, ms. @pre there are frames
  [[nodiscard]] double slowestOf(double percent) const;

 private:
  std::vector<double> milliseconds_;  ///< sorted
};

}  // namespace blossom::test

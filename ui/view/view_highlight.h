#pragma once
#include <vtkSmartPointer.h>

#include <vector>

#include "ui/view/items/view_items.h"

namespace blossom::ui {

/// Parts of shapes in an accent colour, on top of what they are parts of.
class PartHighlight {
 public:
  explicit PartHighlight(vtkRenderer* renderer) : renderer_(renderer) {}

  /// @returns whether anything changed.
  bool set(const std::vector<Pick>&, const ViewItems&);
  void setLook(const Look&, const Color& accent, double strength);
  void setSection(vtkPlane* clip);  ///< nullptr: none
  [[nodiscard]] const std::vector<Pick>& picks() const { return picks_; }

 private:
  void paint() const;
  vtkRenderer* renderer_;
  std::vector<Pick> picks_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
  Look look_ = Look::dark();
  Color accent_;
  double strength_ = 1;
  vtkSmartPointer<vtkPlane> clip_;
};

/// Whether two picks name the same part.
bool samePart(const Pick&, const Pick&);

}  // namespace blossom::ui

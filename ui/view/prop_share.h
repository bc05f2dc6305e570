#pragma once

class vtkProp;

namespace blossom::ui {

/// For frames that are drawn with a share of the pixels along each side of a picture and enlarged to its size: lines, points
/// and what is flat on the screen become that much smaller, so that they look as large as ever. A prop remembers for which
/// share it was made, 1 at first.
void drawAtShare(vtkProp&, double share);

}  // namespace blossom::ui

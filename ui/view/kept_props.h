#pragma once
#include <vtkSmartPointer.h>

#include <vector>

class vtkProp;
class vtkRenderer;

namespace blossom::ui {

/// Shows `now` in place of what was shown before. Where both are made alike, the actors that are there stay and take over
/// what the new ones hold: VTK puts a shader together for every new actor, which takes longer than a frame's whole drawing.
/// @param shown what is in the renderer; of which parts stay. Nobody else may hold them.
void replaceProps(vtkRenderer&, std::vector<vtkSmartPointer<vtkProp>>& shown, std::vector<vtkSmartPointer<vtkProp>> now);

}  // namespace blossom::ui

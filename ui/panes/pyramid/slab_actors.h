// Flat things in space: a quad in one colour, a grid of values as a picture on a quad.
#pragma once

#include <array>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "painting/style.h"

namespace reliefui {

vtkSmartPointer<vtkPolyData> quadOf(const std::array<std::array<double, 3>, 4>& corners);
// Without light: colours mean something.
vtkSmartPointer<vtkActor> flatActor(const vtkSmartPointer<vtkPolyData>& data);
// What the cells' clip shows, thinned out; corners: of the clip, from its least x and y on around.
vtkSmartPointer<vtkActor> slabPicture(const Cells& cells, const Style& style,
                                      const std::array<std::array<double, 3>, 4>& corners);

}  // namespace reliefui

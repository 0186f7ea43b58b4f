// Cylinders, arrow heads and balls of the 3-D trace, each in its colour, as one mesh.
#pragma once

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "painting/style.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

Place between(const Place& a, const Place& b, double f);

class Tubes {
  public:
    Tubes() { colors_->SetNumberOfComponents(4); }

    void add(const Place& from, const Place& to, double radius, Rgba color) { cone(from, to, radius, radius, color); }
    // A tube that is wider or narrower at its end; radius 0: a point.
    void cone(const Place& from, const Place& to, double radius, double endRadius, Rgba color);
    // A tube that ends in a head, at most half as long as the whole.
    void arrow(const Place& from, const Place& to, double radius, Rgba color);
    void ball(const Place& at, double radius, Rgba color);

    vtkSmartPointer<vtkPolyData> take() const;

  private:
    void cell(const std::vector<vtkIdType>& ids, Rgba color);

    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

vtkSmartPointer<vtkActor> actorOf(const vtkSmartPointer<vtkPolyData>& data);
void paintIn(vtkActor* actor, Rgba color);
// Flat colours: a role is told by its colour, which light must not change much.
void lightLittle(vtkActor* actor);

}  // namespace reliefui

// Builds one mesh of coloured cylinders, arrow heads and balls for the 3-D trace.
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
    // A tube with different radii at its ends; radius 0: a tip.
    void cone(const Place& from, const Place& to, double radius, double endRadius, Rgba color);
    // A tube with a head, which is at most half as long as the whole.
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
// Weak shading, because colours identify roles and must not change much.
void shadeWeakly(vtkActor* actor);

}  // namespace reliefui

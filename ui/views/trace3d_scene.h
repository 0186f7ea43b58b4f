// The geometry of the 3-D trace: a patch of the relief around the ray, the slab, the ray's stretches, the box of a
// step. Frame: texels; X = s, Y = -t (so that the picture is not mirrored), Z = height times the slab's thickness times
// an exaggeration. Under repeat counted from the period that the tracer started in.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "drawings/ray_geometry.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Samples of the relief along one side of the patch, at most: larger patches are decimated.
inline constexpr int kPatchSamples = 192;

struct TraceScene {
    TraceScene(const Snapshot& snapshot, double exaggeration);

    Box patch;          // in texels, (s, t)
    double scale = 1;   // Z of the top of the slab
    double bottom = 0;  // Z below which nothing is drawn: a little under the lowest place of the patch
    double end = 1;     // lambda at which the ray ends (hit, or left the field)
    RayPath path;

    vtkSmartPointer<vtkPolyData> relief() const;  // coloured points (bilinear) or cells (columns)
    vtkSmartPointer<vtkPolyData> slabFrame() const;
    vtkSmartPointer<vtkPolyData> ray() const;  // from a little above the slab to its end
    // The stretch of one step, and the box from the bottom to the value under it.
    vtkSmartPointer<vtkPolyData> stretch(const relief::Step& step) const;
    vtkSmartPointer<vtkPolyData> box(const relief::Step& step) const;
    vtkSmartPointer<vtkPolyData> point(double lambda) const;
    void position(double lambda, double out[3]) const;

  private:
    vtkSmartPointer<vtkPolyData> surface(int step, int columns, int rows) const;
    vtkSmartPointer<vtkPolyData> boxes(int step, int columns, int rows) const;
    double lowest() const;  // height, with what is left under it
    void color(double s, double t, double height, unsigned char out[3]) const;

    const Snapshot& snapshot_;
    const relief::HeightField& field_;
};

}  // namespace reliefui

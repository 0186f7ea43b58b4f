// The relief of the 3-D trace: a patch of it around the ray, as a solid block, and the slab's top above it. Frame:
// texels; X = s, Y = -t (so that the picture is not mirrored), Z = height times the slab's thickness times an
// exaggeration. Under repeat counted from the period that the tracer started in.
#pragma once

#include <array>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "panes/ray_geometry.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Samples of the relief along one side of the patch, at most: larger patches are decimated.
inline constexpr int kPatchSamples = 128;

using Place = std::array<double, 3>;

class TraceScene {
  public:
    TraceScene(const Snapshot& snapshot, double exaggeration);

    Box patch;          // in texels, (s, t)
    double scale = 1;   // Z of the top of the slab
    double bottom = 0;  // Z of the block's foot; what lies deeper is cut off
    double end = 1;     // lambda at which the ray ends (hit, or left the field)
    RayPath path;
    int baseLevel = 0;  // of the texels that the steps are about

    double diagonal() const;
    // On the ray, and on the relief under it.
    Place onRay(double lambda) const;
    Place underRay(double lambda) const;

    vtkSmartPointer<vtkPolyData> relief() const;  // coloured points (bilinear) or cells (columns)
    vtkSmartPointer<vtkPolyData> skirt() const;   // the cut sides of the block
    vtkSmartPointer<vtkPolyData> slabFrame() const;

  private:
    double foot() const;
    double underRayAt(double lambda) const;
    double heightAt(double s, double t) const { return field_.at(s, t) * scale; }
    vtkSmartPointer<vtkPolyData> surface() const;
    vtkSmartPointer<vtkPolyData> boxes() const;
    void color(double s, double t, double height, unsigned char out[3]) const;

    const Snapshot& snapshot_;
    const relief::HeightField& field_;
};

// Points joined by lines; closed: back to the first.
vtkSmartPointer<vtkPolyData> lineThrough(const std::vector<Place>& places, bool closed);

}  // namespace reliefui

// The relief of the 3-D trace: a patch around the ray as a solid block, and the top of the slab above it. Frame, in
// texels: X = s, Y = -t (so that the picture is not mirrored), Z = height times the slab's thickness times the
// exaggeration. If the picture repeats, coordinates are relative to the period in which the tracer started.
#pragma once

#include <array>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "panes/ray_geometry.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Largest number of samples per side of the patch; larger patches are decimated.
inline constexpr int kPatchSamples = 128;

using Place = std::array<double, 3>;

class TraceScene {
  public:
    TraceScene(const Snapshot& snapshot, double exaggeration);

    Box patch;          // in texels (s, t)
    double scale = 1;   // Z of the top of the slab
    double bottom = 0;  // Z of the block's bottom; lower parts are cut off
    double end = 1;     // lambda at the ray's end (hit, or exit from the field)
    RayPath path;
    int baseLevel = 0;  // of the steps, see stepBox()

    double diagonal() const;
    // Position on the ray; position on the relief below it.
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

// Polyline through the places; closed: returns to the first.
vtkSmartPointer<vtkPolyData> lineThrough(const std::vector<Place>& places, bool closed);

}  // namespace reliefui

// The relief of the 3-D trace: a patch around the ray as a solid block, and the top of the slab above it. Frame, in
// texels: X = s, Y = -t (so that the picture is not mirrored), Z = height times the slab's thickness times the
// exaggeration. If the picture repeats, coordinates are relative to the period in which the tracer started.
#pragma once

#include <array>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "panes/ray_geometry.h"
#include "panes/turntable.h"
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
    // Where the drawn ray begins, somewhat above the slab.
    Place rayTop() const;
    const relief::HeightField& field() const { return field_; }
    double heightAt(double s, double t) const { return field_.at(s, t) * scale; }  // Z
    // sRGB colour of the relief. height: 0 to 1, used without a picture of colours.
    void color(double s, double t, double height, unsigned char out[3]) const;
    // The camera's room for the whole patch, see Turntable::fit(); faceRay() turns it to the side of the ray.
    void fit(Turntable& camera, double aspect) const;
    void faceRay(Turntable& camera) const;
    // Corner of the slab's top that is leftmost in the view, where its label is clear of the ray and its labels.
    Place topLabelPlace(const Turntable& camera) const;

    vtkSmartPointer<vtkPolyData> relief() const;  // coloured points (bilinear) or cells (columns)
    vtkSmartPointer<vtkPolyData> skirt() const;   // the cut sides of the block
    vtkSmartPointer<vtkPolyData> slabFrame() const;

  private:
    double foot() const;
    double underRayAt(double lambda) const;
    vtkSmartPointer<vtkPolyData> surface() const;
    vtkSmartPointer<vtkPolyData> boxes() const;

    const Snapshot& snapshot_;
    const relief::HeightField& field_;
};

// Samples per texel and side of small patches: a bilinear surface is curved between its heights. A power of two, so
// that half of it is whole, and the heights, at the middles of texels, are among the samples.
inline constexpr int kFinestSamples = 4;
// Positions of the samples along a side of the patch, with both ends: `fine` per texel, or one in `stride` texels.
// middles: if one per texel, then at its middle.
std::vector<double> sampleLines(double low, double high, int fine, int stride, bool middles);

// Polyline through the places; closed: returns to the first.
vtkSmartPointer<vtkPolyData> lineThrough(const std::vector<Place>& places, bool closed);

}  // namespace reliefui

// The relief of the 3-D trace for vector files: cells of the patch around the ray, painted from the farthest to the
// nearest, so that nearer ones cover what they hide; and what of the ray and of other objects the relief hides.
#pragma once

#include <utility>
#include <vector>

#include "painting/style.h"
#include "panes/trace/trace3d_scene.h"
#include "panes/trace/trace_eye.h"

namespace reliefui {

// Largest number of cells; larger patches are drawn with every n-th height. A file of that many takes about a megabyte,
// and LaTeX a few seconds.
inline constexpr double kMostMeshCells = 9216;

class TraceMesh {
  public:
    // A piece of the surface, of a column's sides, or of the cut sides of the block.
    struct Face {
        std::vector<Place> corners;
        Rgba color;
        std::vector<std::vector<std::size_t>> lines;  // corners joined by lines of the mesh
    };

    explicit TraceMesh(const TraceScene& scene);

    int columns() const { return static_cast<int>(s_.size()) - 1; }
    int rows() const { return static_cast<int>(t_.size()) - 1; }
    int stride() const { return stride_; }  // texels between two heights; 1: none is left out

    // From the farthest to the nearest: a face never hides part of a later one. theme: of the page.
    std::vector<Face> faces(const TraceEye& eye, Theme theme) const;
    // Smallest height of the line from a place to the eye over the mesh; negative: the relief hides the place.
    double clearance(const Place& from, const TraceEye& eye) const;
    // Tolerance of clearance() for places on the surface.
    double tolerance() const;

  private:
    double height(std::size_t i, std::size_t j) const { return z_[j * s_.size() + i]; }  // of a node, or of a column
    Rgba cellColor(std::size_t i, std::size_t j) const;
    Rgba shaded(Rgba color, const Place& normal, const TraceEye& eye, double ambient, double diffuse) const;
    // own: column and row of the eye's cell.
    void addCell(std::vector<Face>& faces, std::size_t i, std::size_t j, const TraceEye& eye,
                 std::pair<int, int> own) const;
    void addColumn(std::vector<Face>& faces, std::size_t i, std::size_t j, const TraceEye& eye) const;
    void addSides(std::vector<Face>& faces, const TraceEye& eye, Theme theme, bool near) const;
    bool isLine(double at, double low, double high) const;

    const TraceScene& scene_;
    bool bilinear_;
    int stride_ = 1;
    std::vector<double> s_, t_;  // borders of the cells, in texels
    std::vector<double> z_;      // bilinear: of the borders' crossings; columns: of the cells
};

}  // namespace reliefui

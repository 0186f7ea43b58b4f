// Queries of pixels to a texture filter, single and in blocks.
#pragma once

#include <cmath>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/pixel_view.h"
#include "mapping/footprint.h"
#include "relief/ray.h"

namespace relief {

// A pixel's query: where its ray hit the relief, and how the plane there is projected.
struct FilterQuery {
    glm::dvec2 place{0};  // texels of the height map, unwrapped: where colours are sampled
    Jacobian jacobian;    // texels of the height map per pixel
    ViewRay ray;
    double lambda = 0;
    // Change of the run (a, b) of neighbouring pixels' rays per texel of entry point (s0, t0): 0 for an eye at
    // infinity, otherwise thickness / height of the eye above the plane.
    double spread = 0;
    // The pixel and its view. Null: there is no view, and rays are derived from the Jacobian and the spread.
    const PixelView* view = nullptr;
    int x = 0, y = 0;
    bool exact = false;  // place and lambda are the hit of the view's own ray, by an exact method
};

// Converts a Jacobian to other texels, scale of them per texel of j's.
inline Jacobian scaled(const Jacobian& j, glm::dvec2 scale) {
    return {j.ux * scale.x, j.vx * scale.y, j.uy * scale.x, j.vy * scale.y};
}

// The hits of all rays of a picture, or of `height` of its rows from firstRow on, for filters that read the hits of a
// pixel's neighbours. Pixel (x, y) is at (y - firstRow) * width + x. The hits must come from an exact method. The
// arrays are not owned.
struct PictureHits {
    int width = 0, height = 0;
    const std::uint8_t* polygon = nullptr;  // PixelView::number of the view that the pixel's ray belongs to
    const RayBlock* rays = nullptr;
    const HitBlock* hits = nullptr;
    int firstRow = 0;

    bool hasRow(int y) const { return y >= firstRow && y - firstRow < height; }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y - firstRow) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

// Queries as a structure of arrays, all of one length. Neighbouring pixels should be adjacent.
struct FilterBlock {
    std::vector<double> s, t;
    std::vector<double> ux, vx, uy, vy;
    RayBlock rays;  // used only without a picture, which has its own
    std::vector<double> lambda, spread;
    std::vector<const PixelView*> view;
    std::vector<int> x, y;
    std::vector<std::uint8_t> exact;
    // The picture of these pixels, if all of it has been traced. Null: filters trace again what they need of it.
    const PictureHits* picture = nullptr;

    std::size_t size() const { return s.size(); }
    ViewRay ray(std::size_t i) const {
        return picture == nullptr ? rays[i] : (*picture->rays)[picture->at(x[i], y[i])];
    }
    // The sum of the Jacobian's absolute values.
    double sides(std::size_t i) const { return std::abs(ux[i]) + std::abs(uy[i]) + std::abs(vx[i]) + std::abs(vy[i]); }
    void resize(std::size_t count) {
        for (auto* column : {&s, &t, &ux, &vx, &uy, &vy, &lambda, &spread}) column->resize(count);
        rays.resize(count);
        view.resize(count);
        exact.resize(count);
        for (auto* column : {&x, &y}) column->resize(count);
    }
    FilterQuery operator[](std::size_t i) const {
        return {{s[i], t[i]}, {ux[i], vx[i], uy[i], vy[i]}, ray(i), lambda[i], spread[i], view[i], x[i], y[i],
                exact[i] != 0};
    }
    void set(std::size_t i, const FilterQuery& query) {
        s[i] = query.place.x, t[i] = query.place.y;
        ux[i] = query.jacobian.ux, vx[i] = query.jacobian.vx;
        uy[i] = query.jacobian.uy, vy[i] = query.jacobian.vy;
        rays.set(i, query.ray);
        lambda[i] = query.lambda;
        spread[i] = query.spread;
        view[i] = query.view;
        x[i] = query.x, y[i] = query.y;
        exact[i] = query.exact ? 1 : 0;
    }
    // Sets only what plain filtering reads of a query.
    void place(std::size_t i, glm::dvec2 at, const Jacobian& j) {
        s[i] = at.x, t[i] = at.y;
        ux[i] = j.ux, vx[i] = j.vx;
        uy[i] = j.uy, vy[i] = j.vy;
    }
    void push(const FilterQuery& query) {
        resize(size() + 1);
        set(size() - 1, query);
    }
};

}  // namespace relief

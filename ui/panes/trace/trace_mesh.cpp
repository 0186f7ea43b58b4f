#include "panes/trace/trace_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace reliefui {

namespace {

// Index of the interval of sorted borders that contains `at`: -1 before the first, the last border's index behind it.
int cellOf(const std::vector<double>& borders, double at) {
    return static_cast<int>(std::upper_bound(borders.begin(), borders.end(), at) - borders.begin()) - 1;
}

// Indices of cells from the farthest to the nearest of `own`, the cell of the eye.
std::vector<std::size_t> inward(int cells, int own) {
    std::vector<std::size_t> order;
    for (int k = 0; k < cells; ++k) order.push_back(static_cast<std::size_t>(k));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(static_cast<int>(a) - own) > std::abs(static_cast<int>(b) - own);
    });
    return order;
}

Place normalOf(const std::vector<Place>& p) {
    const Place& a = p[0];
    const Place& b = p[1];
    const Place& c = p[2];
    const Place& d = p.size() > 3 ? p[3] : p[0];
    const Place u{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Place v{d[0] - b[0], d[1] - b[1], d[2] - b[2]};
    Place n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (double& part : n) part = length > 0 ? part / length : 0;
    return n;
}

// The part of a polygon at or above a height; its lines are kept only if nothing is cut off.
void cutBelow(TraceMesh::Face& face, double bottom) {
    const std::vector<Place>& p = face.corners;
    if (std::all_of(p.begin(), p.end(), [&](const Place& c) { return c[2] >= bottom; })) return;
    std::vector<Place> kept;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Place& a = p[k];
        const Place& b = p[(k + 1) % p.size()];
        if (a[2] >= bottom) kept.push_back(a);
        if ((a[2] < bottom) == (b[2] < bottom)) continue;
        const double f = (bottom - a[2]) / (b[2] - a[2]);
        kept.push_back({a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), bottom});
    }
    face.corners = std::move(kept);
    face.lines.clear();
}

}  // namespace

TraceMesh::TraceMesh(const TraceScene& scene)
    : scene_(scene), bilinear_(scene.field().surface() == relief::Surface::Bilinear) {
    const Box& patch = scene.patch;
    const double texels = patch.width() * patch.height();
    int fine = bilinear_ ? kFinestSamples : 1;
    while (fine > 1 && texels * fine * fine > kMostMeshCells) fine /= 2;
    while (std::ceil(patch.width() / stride_) * std::ceil(patch.height() / stride_) > kMostMeshCells) ++stride_;
    s_ = sampleLines(patch.x0, patch.x1, fine, stride_, bilinear_);
    t_ = sampleLines(patch.y0, patch.y1, fine, stride_, bilinear_);
    for (const double t : t_) {
        for (const double s : s_) {
            const bool cell = s < patch.x1 && t < patch.y1;
            const auto texel = [](double at) { return static_cast<std::int64_t>(std::floor(at)); };
            const double z = bilinear_ ? scene.heightAt(s, t)
                             : cell    ? static_cast<double>(scene.field().texel(texel(s), texel(t))) * scene.scale
                                       : 0;
            z_.push_back(z);
        }
    }
}

Rgba TraceMesh::cellColor(std::size_t i, std::size_t j) const {
    const double s = (s_[i] + s_[i + 1]) / 2;
    const double t = (t_[j] + t_[j + 1]) / 2;
    const double z = bilinear_ ? scene_.heightAt(s, t) : height(i, j);
    unsigned char rgb[3];
    scene_.color(s, t, z / scene_.scale, rgb);
    return {rgb[0], rgb[1], rgb[2], 255};
}

// The light of the pane (addLight() in trace3d_picture.cpp): it comes from the upper left behind the viewer, and each
// side of a face is lit.
Rgba TraceMesh::shaded(Rgba color, const Place& normal, const TraceEye& eye, double ambient, double diffuse) const {
    constexpr Place kLight{-0.6, 0.8, 0.9};
    static const double length = std::hypot(kLight[0], kLight[1], kLight[2]);
    const Place n = eye.turned(normal);
    const double side = n[2] < 0 ? -1 : 1;
    const double cosine = side * (n[0] * kLight[0] + n[1] * kLight[1] + n[2] * kLight[2]) / length;
    const double factor = ambient + diffuse * std::max(0.0, cosine);
    const auto lit = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::min(255.0, c * factor + 0.5)); };
    return {lit(color.r), lit(color.g), lit(color.b), 255};
}

// Returns true if a border of cells is a line of the mesh: through the heights of a bilinear surface, around columns.
bool TraceMesh::isLine(double at, double low, double high) const {
    if (at == low || at == high || !bilinear_ || stride_ > 1) return true;
    return at - std::floor(at) == 0.5;
}

void TraceMesh::addCell(std::vector<Face>& faces, std::size_t i, std::size_t j, const TraceEye& eye,
                        std::pair<int, int> own) const {
    Face face;
    for (const auto& [di, dj] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}, std::pair{1, 0}}) {
        const std::size_t a = i + static_cast<std::size_t>(di);
        const std::size_t b = j + static_cast<std::size_t>(dj);
        face.corners.push_back({s_[a], -t_[b], height(a, b)});
    }
    face.color = shaded(cellColor(i, j), normalOf(face.corners), eye, 0.3, 0.85);
    const Box& p = scene_.patch;
    const auto index = [](std::size_t k) { return static_cast<int>(k); };
    // A line between two cells is drawn once, with the one that is painted later.
    const bool lines[4] = {
        isLine(s_[i], p.x0, p.x1) && (index(i) <= own.first || i == 0),
        isLine(t_[j + 1], p.y0, p.y1) && (index(j) >= own.second || j + 2 == t_.size()),
        isLine(s_[i + 1], p.x0, p.x1) && (index(i) >= own.first || i + 2 == s_.size()),
        isLine(t_[j], p.y0, p.y1) && (index(j) <= own.second || j == 0),
    };
    for (std::size_t k = 0; k < 4; ++k) {
        if (!lines[k]) continue;
        if (k == 0 || !lines[k - 1]) face.lines.push_back({k});
        face.lines.back().push_back((k + 1) % 4);
    }
    if (face.lines.size() > 1 && lines[3] && lines[0]) {
        face.lines.back().insert(face.lines.back().end(), face.lines.front().begin() + 1, face.lines.front().end());
        face.lines.erase(face.lines.begin());
    }
    cutBelow(face, scene_.bottom);
    if (face.corners.size() > 2) faces.push_back(std::move(face));
}

// The top, and the sides towards the eye down to the neighbours there: sides and top do not hide each other.
void TraceMesh::addColumn(std::vector<Face>& faces, std::size_t i, std::size_t j, const TraceEye& eye) const {
    const double z = height(i, j);
    const Place& from = eye.place();
    const auto add = [&](const std::vector<Place>& corners, Rgba color) {
        Face face{corners, shaded(color, normalOf(corners), eye, 0.3, 0.85), {{0, 1, 2, 3, 0}}};
        cutBelow(face, scene_.bottom);
        if (face.corners.size() > 2) faces.push_back(std::move(face));
    };
    // Walls have the colour of their left or upper column.
    const double x0 = s_[i], x1 = s_[i + 1], y0 = -t_[j], y1 = -t_[j + 1];
    const bool right = from[0] > x1 && i + 2 < s_.size();
    const bool left = from[0] < x0 && i > 0;
    const bool above = from[1] > y0 && j > 0;
    const bool below = from[1] < y1 && j + 2 < t_.size();
    const auto wall = [&](bool there, std::size_t ni, std::size_t nj, Point a, Point b, Rgba color) {
        if (!there || height(ni, nj) >= z) return;
        const double low = height(ni, nj);
        add({{a.x, a.y, z}, {b.x, b.y, z}, {b.x, b.y, low}, {a.x, a.y, low}}, color);
    };
    const Rgba own = cellColor(i, j);
    if (right) wall(true, i + 1, j, {x1, y0}, {x1, y1}, own);
    if (left) wall(true, i - 1, j, {x0, y0}, {x0, y1}, cellColor(i - 1, j));
    if (below) wall(true, i, j + 1, {x0, y1}, {x1, y1}, own);
    if (above) wall(true, i, j - 1, {x0, y0}, {x1, y0}, cellColor(i, j - 1));
    if (from[2] > z) add({{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}}, own);
}

// The cut sides of the block: those that face the eye hide the others and the cells.
void TraceMesh::addSides(std::vector<Face>& faces, const TraceEye& eye, Theme theme, bool near) const {
    const std::uint8_t grey = theme == Theme::Dark ? 82 : 184;
    const Rgba color{grey, grey, static_cast<std::uint8_t>(grey * 1.04), 255};
    const Box& p = scene_.patch;
    const Place& from = eye.place();
    const auto side = [&](bool seen, const std::vector<double>& along, bool isRow, std::size_t at, double fixed) {
        if (seen != near) return;
        const auto place = [&](double a, double z) { return isRow ? Place{a, -fixed, z} : Place{fixed, -a, z}; };
        const auto heightOf = [&](std::size_t k) { return isRow ? height(k, at) : height(at, k); };
        Face face;
        for (std::size_t k = 0; k < along.size(); ++k) {
            const double z = std::max(scene_.bottom, heightOf(bilinear_ ? k : std::min(k, along.size() - 2)));
            if (!bilinear_ && k > 0) {
                face.corners.push_back(place(along[k], std::max(scene_.bottom, heightOf(k - 1))));
            }
            if (bilinear_ || k + 1 < along.size()) face.corners.push_back(place(along[k], z));
        }
        face.corners.push_back(place(along.back(), scene_.bottom));
        face.corners.push_back(place(along.front(), scene_.bottom));
        const Place normal = isRow ? Place{0, 1, 0} : Place{1, 0, 0};
        face.color = shaded(color, normal, eye, 0.6, 0.4);
        faces.push_back(std::move(face));
    };
    const std::size_t lastColumn = bilinear_ ? s_.size() - 1 : s_.size() - 2;
    const std::size_t lastRow = bilinear_ ? t_.size() - 1 : t_.size() - 2;
    side(-from[1] < p.y0, s_, true, 0, p.y0);
    side(-from[1] > p.y1, s_, true, lastRow, p.y1);
    side(from[0] < p.x0, t_, false, 0, p.x0);
    side(from[0] > p.x1, t_, false, lastColumn, p.x1);
}

// Along a line from the eye, the distances of its cells from the eye's cell, in rows and in columns, never decrease. So
// no cell hides one that comes after it row by row towards the eye's row, and within a row towards its column.
std::vector<TraceMesh::Face> TraceMesh::faces(const TraceEye& eye, Theme theme) const {
    std::vector<Face> faces;
    addSides(faces, eye, theme, false);
    const int ownColumn = cellOf(s_, eye.place()[0]);
    const int ownRow = cellOf(t_, -eye.place()[1]);
    for (const std::size_t j : inward(rows(), ownRow)) {
        for (const std::size_t i : inward(columns(), ownColumn)) {
            bilinear_ ? addCell(faces, i, j, eye, {ownColumn, ownRow}) : addColumn(faces, i, j, eye);
        }
    }
    addSides(faces, eye, theme, true);
    return faces;
}

double TraceMesh::tolerance() const {
    constexpr double kShare = 0.004;  // of the scene's diagonal, about the radius of the drawn ray
    return kShare * scene_.diagonal();
}

double TraceMesh::clearance(const Place& from, const TraceEye& eye) const {
    const Place& to = eye.place();
    const Point a{from[0], -from[1]};
    const Point d{to[0] - from[0], -to[1] - a.y};
    // The part of the line within the patch and not above the slab.
    double begin = 0;
    double end = 1;
    const auto limit = [&](double at, double by, double low, double high) {
        if (by == 0) {
            if (at < low || at > high) end = -1;
            return;
        }
        const double u = (low - at) / by;
        const double v = (high - at) / by;
        begin = std::max(begin, std::min(u, v));
        end = std::min(end, std::max(u, v));
    };
    const Box& p = scene_.patch;
    limit(a.x, d.x, p.x0, p.x1);
    limit(a.y, d.y, p.y0, p.y1);
    const double rise = to[2] - from[2];
    if (rise > 0) end = std::min(end, (scene_.scale - from[2]) / rise);
    double least = 1e300;
    if (end <= begin) return least;
    const auto inside = [](const std::vector<double>& borders, double at) {
        return static_cast<std::size_t>(std::clamp(cellOf(borders, at), 0, static_cast<int>(borders.size()) - 2));
    };
    const auto overAt = [&](double u, std::size_t i, std::size_t j) {
        const double z = from[2] + u * rise;
        if (!bilinear_) return z - std::max(height(i, j), scene_.bottom);
        const double x = std::clamp((a.x + u * d.x - s_[i]) / (s_[i + 1] - s_[i]), 0.0, 1.0);
        const double y = std::clamp((a.y + u * d.y - t_[j]) / (t_[j + 1] - t_[j]), 0.0, 1.0);
        const double upper = height(i, j) + x * (height(i + 1, j) - height(i, j));
        const double lower = height(i, j + 1) + x * (height(i + 1, j + 1) - height(i, j + 1));
        return z - std::max(upper + y * (lower - upper), scene_.bottom);
    };
    double u = begin;
    constexpr double kStep = 1e-9;  // into the next cell
    while (u < end) {
        const double into = std::min(end, u + kStep);
        const std::size_t i = inside(s_, a.x + into * d.x);
        const std::size_t j = inside(t_, a.y + into * d.y);
        double next = end;
        if (d.x != 0) next = std::min(next, ((d.x > 0 ? s_[i + 1] : s_[i]) - a.x) / d.x);
        if (d.y != 0) next = std::min(next, ((d.y > 0 ? t_[j + 1] : t_[j]) - a.y) / d.y);
        next = std::max(next, into);
        for (const double f : {0.0, 0.5, 1.0}) least = std::min(least, overAt(u + f * (next - u), i, j));
        u = next;
    }
    return least;
}

}  // namespace reliefui

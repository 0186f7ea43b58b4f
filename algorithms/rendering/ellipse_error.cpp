#include "rendering/ellipse_error.h"

#include <algorithm>

#include "filtering/ellipse_rows.h"

namespace relief {

double ellipseError(const Frame& part, const FrameRequest& request, Work& work) {
    const auto name = request.filter.options.find("ellipse");
    const EllipseForm form = name == request.filter.options.end() ? EllipseForm::Direct : ellipseForm(name->second);
    if (form == EllipseForm::Direct) return 0;
    const VisiblePolygons visible = part.visible(request);
    double most = 0;
    for (int y = part.rows.begin; y < part.rows.end; ++y) {
        work.throwIfStopped();
        FilterBlock row, own;
        for (int x = 0; x < part.width; ++x) {
            if (const auto query = filterQuery(part, request, visible, x, y)) row.push(*query);
        }
        ellipseRows(form, row, own);
        most = std::max(most, largestAxisDifference(own, row));
    }
    return most;
}

}  // namespace relief

#include "panes/doctor/doctor_drawing.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "painting/legend_rows.h"

namespace reliefui {

Drawing doctorPicture(const DoctorReport& report, std::optional<std::size_t> chosen) {
    const relief::FloatImage& picture = *report.picture;
    Drawing drawing;
    Cells cells;
    cells.values = report.picture;
    cells.map = ColorMap::Picture;
    cells.clip = {0, 0, static_cast<double>(picture.width()), static_cast<double>(picture.height())};
    drawing.bounds = cells.clip;
    drawing.add({ItemKind::Layer, 0, 0, 0}, Role::Frame, std::move(cells));
    if (!chosen || *chosen >= report.rays.size()) return drawing;
    const relief::PixelChoice at = report.places[*chosen];
    drawing.add({}, Role::Hit, Ring{{at.x + 0.5, at.y + 0.5}});
    return drawing;
}

Drawing doctorLegend(const DoctorReport& report, bool lines, double width, relief::Language language) {
    LegendRows rows(width, language);
    rows.words(relief::Message(report.view ? relief::MessageId::DoctorOfView : relief::MessageId::DoctorOfMap));
    rows.newRow();
    for (std::size_t n = 0; lines && n < report.lines.size(); ++n) {
        rows.words(report.lines[n]);
        rows.newRow();
    }
    return rows.take();
}

std::optional<std::size_t> doctorRayAt(const DoctorReport& report, Point at) {
    const auto x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    if (x < 0 || y < 0 || x >= report.rayAt.width() || y >= report.rayAt.height()) return std::nullopt;
    const int ray = report.rayAt(x, y);
    if (ray < 0) return std::nullopt;
    return static_cast<std::size_t>(ray);
}

std::shared_ptr<const Figure> doctorFigure(std::shared_ptr<const DoctorReport> report) {
    ChartMaker maker;
    maker.legend = [report](double width, relief::Language language) {
        return doctorLegend(*report, true, width, language);
    };
    maker.layers = [report](double, double, const Style&) { return std::vector{doctorPicture(*report, {})}; };
    const auto caption = [report](relief::Language language) {
        const std::string file = std::filesystem::path(report->subject.scenario.other.steps).filename().string();
        return relief::sentence(relief::Message(relief::MessageId::DoctorCaption, {{"file", file}}), language);
    };
    return chartFigure(std::move(maker), caption);
}

std::shared_ptr<const Figure> diagnosedFigure(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario&) {
    if (!snapshot->request) throw EmptyFigure("doctor", relief::MessageId::DrawNoPicture);
    if (!snapshot->scenario.other) throw EmptyFigure("doctor", relief::MessageId::DoctorNone);
    relief::Work work;
    return doctorFigure(doctorReport(*snapshot, work));
}

}  // namespace reliefui

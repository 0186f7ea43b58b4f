#include "painting/legend_rows.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

void addHeights(LegendRows& rows, double slabTexels) {
    static constexpr int kRampCells = 64;
    constexpr double kBar = 56;
    constexpr double kDigit = 8;
    const Message name(MessageId::DrawHeightLegend, {{"texels", relief::numberText(slabTexels, 3)}});
    const Point at = rows.place(2 * kDigit + kBar + 14 + rows.textRoom(name));
    static const auto ramp = [] {
        auto values = std::make_shared<relief::FloatImage>(kRampCells, 1);
        for (int i = 0; i < kRampCells; ++i) (*values)(i, 0) = static_cast<float>(i) / (kRampCells - 1);
        return std::shared_ptr<const relief::FloatImage>(values);
    }();
    Cells bar;
    bar.values = ramp;
    bar.x = at.x + kDigit;
    bar.y = at.y - 5;
    bar.cellWidth = kBar / kRampCells;
    bar.cellHeight = 10;
    bar.clip = {bar.x, bar.y, bar.x + kBar, bar.y + 10};
    rows.text(at, plainText("0"));
    rows.add(Role::HeightFill, bar);
    rows.add(Role::Frame, Rectangle{bar.clip, false, 0, 0});
    rows.text({at.x + kDigit + kBar + 3, at.y}, plainText("1"));
    rows.text({at.x + 2 * kDigit + kBar + 5, at.y}, name);
}

}  // namespace

Drawing pyramidLegend(const PyramidSource& source, double width, relief::Language language) {
    LegendRows rows(width, language);
    addHeights(rows, source.field->slabTexels());
    if (source.hasRay) {
        rows.line(Role::Ray, Message(MessageId::DrawRay));
        rows.decisions(
            decisionsSeen(source.overCells ? source.steps : nullptr, source.hit.outcome == relief::Outcome::Hit));
    }
    return rows.take();
}

}  // namespace reliefui

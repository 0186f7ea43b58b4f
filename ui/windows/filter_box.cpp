#include "windows/filter_box.h"

#include <algorithm>
#include <charconv>

#include <QLabel>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/options_form.h"

namespace reliefui {

namespace {

constexpr const char* kSamples = "samples";
constexpr const char* kPixelModel = "pixel-model";

// Fields of the choice that are no options of a texture filter, described like those.
void describeSamples(relief::MethodDescription& out, relief::PixelModel model) {
    relief::OptionDescription samples;
    samples.name = kSamples;
    samples.kind = relief::OptionKind::Integer;
    samples.low = relief::fewestSamples(model);
    samples.high = relief::kMaxSamples;
    samples.step = 1;
    samples.help = "samples along each side of a pixel";
    relief::OptionDescription models;
    models.name = kPixelModel;
    models.kind = relief::OptionKind::Choice;
    models.choices.assign(relief::kPixelModelNames.begin(), relief::kPixelModelNames.end());
    models.help = "what a pixel of the display is: how samples are weighed";
    out.options = {samples, models};
    // Another range asks for other controls.
    if (samples.low > 1) out.name += " from " + relief::numberText(samples.low);
}

}  // namespace

FilterBox::FilterBox(Workspace* workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), help_(new QLabel(this)), options_(new OptionsForm(this)) {
    setObjectName(QStringLiteral("filter-box"));
    help_->setWordWrap(true);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(help_);
    column->addWidget(options_);
    connect(workspace_, &Workspace::scenarioChanged, this, &FilterBox::refresh);
    connect(options_, &OptionsForm::settled, workspace_, &Workspace::settle);
    connect(options_, &OptionsForm::changed, this, &FilterBox::change);
    refresh();
}

void FilterBox::change(const QString& name, const QString& text, bool live) {
    relief::Scenario scenario = workspace_->scenario();
    const std::string value = text.toStdString();
    if (scenario.filter.name != relief::kSupersample) {
        scenario.filter.options[name.toStdString()] = value;
    } else if (name == QLatin1String(kPixelModel)) {
        scenario.filter.pixelModel = relief::parsePixelModel(value);
        scenario.filter.samples = std::max(scenario.filter.samples, relief::fewestSamples(scenario.filter.pixelModel));
    } else {
        std::from_chars(value.data(), value.data() + value.size(), scenario.filter.samples);
    }
    workspace_->change(scenario, optionTitle(name.toStdString()), QStringLiteral("filter-") + name, live);
}

void FilterBox::refresh() {
    const relief::FilterChoice& choice = workspace_->scenario().filter;
    const relief::FilterDescription& filter = relief::findFilter(choice.name);
    relief::MethodDescription described;
    described.name = filter.name;
    described.options = filter.options;
    described.defaults = filter.defaults;
    relief::MethodChoice values{filter.name, choice.options};
    if (filter.name == relief::kSupersample) {
        describeSamples(described, choice.pixelModel);
        values.options = {{kSamples, std::to_string(choice.samples)},
                          {kPixelModel, std::string(relief::pixelModelName(choice.pixelModel))}};
    }
    help_->setText(tr("<b>%1</b>. %2").arg(QString::fromStdString(filter.name), coreText(filter.help)));
    help_->setToolTip(QString::fromStdString(filter.source));
    options_->setVisible(!described.options.empty());
    options_->show(described, values);
}

}  // namespace reliefui

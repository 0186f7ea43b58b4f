#include "windows/scene_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "panes/core_texts.h"
#include "panes/number_control.h"
#include "panes/options_form.h"
#include "panes/orbit.h"
#include "rendering/scene.h"
#include "scenario/row_methods.h"
#include "windows/filter_box.h"
#include "windows/pictures_box.h"
#include "workspace/change_name.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

const std::vector<std::string>& surfaces() {
    static const std::vector<std::string> names{std::string(relief::surfaceName(relief::Surface::Bilinear)),
                                                std::string(relief::surfaceName(relief::Surface::Columns))};
    return names;
}

const std::vector<std::string>& addresses() {
    static const std::vector<std::string> names{std::string(relief::addressName(relief::Address::Repeat)),
                                                std::string(relief::addressName(relief::Address::Clamp)),
                                                std::string(relief::addressName(relief::Address::Border))};
    return names;
}

const std::vector<std::string>& scenes() {
    static const std::vector<std::string> names{std::string(relief::sceneName(relief::SceneKind::Floor)),
                                                std::string(relief::sceneName(relief::SceneKind::Wall)),
                                                std::string(relief::sceneName(relief::SceneKind::Cube))};
    return names;
}

// Entries are spelled as in commands and files. A variant from a file may have options that the list does not offer; it
// is added.
void offerMapping(QComboBox* box, const std::string& mapping) {
    const QString text = QString::fromStdString(mapping);
    if (box->findData(text) < 0) box->addItem(text, text);
}

}  // namespace

const std::vector<ViewPreset>& viewPresets() {
    static const std::vector<ViewPreset> presets{{QT_TRANSLATE_NOOP("reliefui::ScenePanel", "from the front"), 85, 1.2},
                                                 {QT_TRANSLATE_NOOP("reliefui::ScenePanel", "slanted"), 35, 1.2},
                                                 {QT_TRANSLATE_NOOP("reliefui::ScenePanel", "grazing"), 10, 1},
                                                 {QT_TRANSLATE_NOOP("reliefui::ScenePanel", "slanted, near"), 35, 0.4}};
    return presets;
}

// A floor is viewed from above, a wall from the front; of a cube three sides are visible.
relief::Camera presetCamera(const ViewPreset& preset, relief::SceneKind scene) {
    constexpr double kRight = 90;
    constexpr double kTurned = -30;
    constexpr double kAbove = 4;
    relief::Camera camera;
    camera.distance = preset.distance;
    const bool wall = scene == relief::SceneKind::Wall;
    camera.elevation = wall ? kAbove : preset.angle;
    camera.azimuth = wall ? preset.angle - kRight : kTurned;
    if (scene == relief::SceneKind::Cube) camera.distance += 1;
    return camera;
}

void changeNumber(Workspace& workspace, const std::string& name, double value, bool live) {
    relief::Scenario scenario = workspace.scenario();
    if (name == "elevation" || name == "azimuth" || name == "distance") scenario.camera = asOrbit(scenario.camera);
    relief::scenarioNumber(name).set(scenario, value);
    workspace.change(scenario, changeName([name] { return controlTitle(name); }), QString::fromStdString(name), live);
}

NumberControl* makeNumberControl(Workspace* workspace, const std::string& name, QWidget* parent) {
    const relief::ScenarioNumber& number = relief::scenarioNumber(name);
    auto* const control = new NumberControl(number.description, parent);
    const auto refresh = [workspace, control, &number] { control->setValue(number.get(workspace->scenario())); };
    QObject::connect(workspace, &Workspace::scenarioChanged, control, refresh);
    QObject::connect(control, &NumberControl::changed, workspace,
                     [workspace, name](double value, bool live) { changeNumber(*workspace, name, value, live); });
    QObject::connect(control, &NumberControl::editFinished, workspace, &Workspace::finishInteraction);
    refresh();
    return control;
}

ScenePanel::ScenePanel(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
    setObjectName(QStringLiteral("scene-panel"));
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    auto* const pictures = new QGroupBox(tr("Pictures"), this);
    auto* const inside = new QVBoxLayout(pictures);
    inside->setContentsMargins(6, 4, 6, 6);
    inside->addWidget(new PicturesBox(workspace, pictures));
    column->addWidget(pictures);
    addSurface(addGroup(column, tr("Relief")));
    QFormLayout* const camera = addGroup(column, tr("Camera"));
    addViews(camera);
    addNumbers(camera, {"elevation", "azimuth", "distance", "fov"});
    QFormLayout* const light = addGroup(column, tr("Light"));
    addNumbers(light, {"light-elevation", "light-azimuth", "ambient", "intensity"});
    addShadows(light);
    addMethod(addGroup(column, tr("Method")));
    addGroup(column, tr("Filter"))->addRow(new FilterBox(workspace, this));
    QFormLayout* const drawn = addGroup(column, tr("Picture drawn"));
    addNumbers(drawn, {"width", "height", "bounded"});
    addMapping(drawn);
    column->addStretch(1);
    connect(workspace_, &Workspace::scenarioChanged, this, &ScenePanel::refresh);
    connect(workspace_, &Workspace::snapshotChanged, this, &ScenePanel::refreshMethod);
    refresh();
}

QFormLayout* ScenePanel::addGroup(QVBoxLayout* column, const QString& title) {
    auto* const group = new QGroupBox(title, this);
    auto* const form = new QFormLayout(group);
    form->setContentsMargins(6, 4, 6, 6);
    form->setVerticalSpacing(3);
    column->addWidget(group);
    return form;
}

void ScenePanel::addNumbers(QFormLayout* form, const std::vector<const char*>& names) {
    for (const char* const name : names) {
        auto* const control = makeNumberControl(workspace_, name, this);
        auto* const label = new QLabel(controlTitle(name), this);
        label->setBuddy(control);
        label->setToolTip(control->toolTip());
        form->addRow(label, control);
    }
}

QComboBox* ScenePanel::addChoice(QFormLayout* form, const QString& title, const QString& objectName,
                                 const QString& help, const std::vector<std::string>& names) {
    auto* const box = new QComboBox(this);
    box->setObjectName(objectName);
    box->setAccessibleName(title);
    box->setToolTip(help);
    for (const std::string& name : names) box->addItem(controlTitle(name), QString::fromStdString(name));
    form->addRow(title, box);
    return box;
}

void ScenePanel::addSurface(QFormLayout* form) {
    addNumbers(form, {"relief-depth"});
    surface_ = addChoice(form, tr("Surface"), QStringLiteral("surface"),
                         tr("Surface between texels: a smooth patch, or one box per texel"), surfaces());
    address_ = addChoice(form, tr("Outside"), QStringLiteral("address"),
                         tr("Relief beyond the picture's rim: the picture again, the heights of its rim, or none"),
                         addresses());
    scene_ = addChoice(form, tr("Scene"), QStringLiteral("scene"), tr("Surface that carries the relief"), scenes());
    connect(surface_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.surface = relief::parseSurface(surface_->currentData().toString().toStdString());
        workspace_->change(scenario, changeName([] { return tr("Surface"); }));
    });
    connect(address_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.address = relief::parseAddress(address_->currentData().toString().toStdString());
        workspace_->change(scenario, changeName([] { return tr("Outside"); }));
    });
    connect(scene_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.scene = relief::parseScene(scene_->currentData().toString().toStdString());
        workspace_->change(scenario, changeName([] { return tr("Scene"); }));
    });
}

void ScenePanel::addViews(QFormLayout* form) {
    auto* const box = addChoice(form, tr("View"), QStringLiteral("view-preset"),
                                tr("Common views; drag in the picture for any other"), {});
    box->addItem(tr("presets…"));
    for (const ViewPreset& preset : viewPresets()) box->addItem(tr(preset.name));
    connect(box, qOverload<int>(&QComboBox::activated), this, [this, box](int item) {
        box->setCurrentIndex(0);
        if (item < 1) return;
        relief::Scenario scenario = workspace_->scenario();
        const double fov = scenario.camera.fov;
        scenario.camera = presetCamera(viewPresets()[static_cast<std::size_t>(item - 1)], scenario.scene);
        scenario.camera.fov = fov;
        workspace_->change(scenario, changeName([] { return tr("View"); }));
    });
}

void ScenePanel::addDefaults(QFormLayout* form) {
    defaults_ = new QToolButton(this);
    defaults_->setObjectName(QStringLiteral("method-defaults"));
    defaults_->setText(tr("defaults"));
    defaults_->setToolTip(tr("Set all options of the method to their defaults"));
    defaults_->setAccessibleName(defaults_->toolTip());
    defaults_->setAutoRaise(true);
    form->addRow(defaults_);
    connect(defaults_, &QToolButton::clicked, this, [this] {
        relief::Scenario scenario = workspace_->scenario();
        scenario.method.options.clear();
        workspace_->change(scenario, changeName([] { return tr("Defaults of the method"); }));
    });
}

void ScenePanel::addShadows(QFormLayout* form) {
    shadows_ = new QCheckBox(tr("Shadows"), this);
    shadows_->setObjectName(QStringLiteral("shadows"));
    shadows_->setToolTip(tr("The relief casts shadows on itself"));
    form->addRow(shadows_);
    connect(shadows_, &QCheckBox::clicked, this, [this](bool on) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.shadows = on;
        workspace_->change(scenario, changeName([] { return tr("Shadows"); }));
    });
}

void ScenePanel::addMapping(QFormLayout* form) {
    mapping_ = addChoice(form, tr("Coordinates"), QStringLiteral("mapping"),
                         tr("Method for texture coordinates along a row of pixels: direct is exact; affine bends "
                            "walls; subspan bends them between its divisions"),
                         {});
    for (const std::string& name : relief::mappingNames()) offerMapping(mapping_, name);
    offerMapping(mapping_, "incremental:anchor=0");
    offerMapping(mapping_, "streams:anchor=0");
    connect(mapping_, qOverload<int>(&QComboBox::activated), this, [this](int) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.mapping = mapping_->currentData().toString().toStdString();
        workspace_->change(scenario, changeName([] { return tr("Coordinates"); }));
    });
}

void ScenePanel::addMethod(QFormLayout* form) {
    for (QLabel** const label : {&help_, &guarantee_}) {
        *label = new QLabel(this);
        (*label)->setWordWrap(true);
        form->addRow(*label);
    }
    guarantee_->setObjectName(QStringLiteral("guarantee"));
    options_ = new OptionsForm(this);
    form->addRow(options_);
    addDefaults(form);
    connect(options_, &OptionsForm::editFinished, workspace_, &Workspace::finishInteraction);
    connect(options_, &OptionsForm::changed, this, [this](const QString& name, const QString& text, bool live) {
        relief::Scenario scenario = workspace_->scenario();
        // Options of a nested method are dropped when another one is chosen.
        const std::string inside = name.toStdString() + ".";
        std::erase_if(scenario.method.options, [&](const auto& option) { return option.first.starts_with(inside); });
        scenario.method.options[name.toStdString()] = text.toStdString();
        workspace_->change(scenario, changeName([name] { return optionTitle(name.toStdString()); }),
                           QStringLiteral("option-") + name, live);
    });
}

void ScenePanel::refresh() {
    const PauseLog::Part part("scene");
    const relief::Scenario& scenario = workspace_->scenario();
    const auto choose = [](QComboBox* box, std::string_view name) {
        box->setCurrentIndex(box->findData(QString::fromUtf8(name.data(), static_cast<int>(name.size()))));
    };
    choose(surface_, relief::surfaceName(scenario.surface));
    choose(address_, relief::addressName(scenario.address));
    choose(scene_, relief::sceneName(scenario.scene));
    offerMapping(mapping_, scenario.mapping);
    choose(mapping_, scenario.mapping);
    shadows_->setChecked(scenario.shadows);
    const relief::MethodDescription& method = relief::findTracer(scenario.method.name);
    help_->setText(tr("<b>%1</b>. %2").arg(QString::fromStdString(method.name), coreText(method.help)));
    help_->setToolTip(QString::fromStdString(method.source));
    options_->show(method, scenario.method);
    defaults_->setVisible(!method.options.empty());
    defaults_->setEnabled(!scenario.method.options.empty());
    refreshMethod();
}

void ScenePanel::refreshMethod() {
    const relief::MethodDescription& method = relief::findTracer(workspace_->scenario().method.name);
    const auto snapshot = workspace_->snapshot();
    const bool made = snapshot && snapshot->scenario.method == workspace_->scenario().method;
    const relief::Guarantee guarantee = made ? snapshot->guarantee : method.guarantee;
    QStringList on;
    for (const relief::Surface surface : method.surfaces) {
        on << controlTitle(std::string(relief::surfaceName(surface))).toLower();
    }
    QString text =
        coreText(std::string(relief::guaranteeName(guarantee))) + QStringLiteral(" · ") + on.join(QStringLiteral(", "));
    if (made) {
        const double megabytes = static_cast<double>(snapshot->methodBytes) / (1024.0 * 1024.0);
        text += QStringLiteral(" · ") +
                (snapshot->methodBytes == 0
                     ? tr("no maps")
                     : tr("maps %1 MiB").arg(QString::fromStdString(relief::numberText(megabytes, 3))));
    }
    guarantee_->setText(QStringLiteral("<small>%1</small>").arg(text));
    guarantee_->setToolTip(
        tr("Guarantee of the method with these options, the surfaces that it supports, and the memory of its maps "
           "besides the heights"));
}

// The pane has more controls than fit, so it scrolls. It is never narrower than its controls, which change with the
// method: a wider option would lie under the scroll bar.
class SceneArea : public QScrollArea {
  public:
    using QScrollArea::QScrollArea;

    QSize minimumSizeHint() const override {
        const int controls = widget() != nullptr ? widget()->minimumSizeHint().width() : 0;
        return {controls + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

PaneKind scenePane() {
    PaneKind kind;
    kind.name = QStringLiteral("scene");
    kind.title = ScenePanel::tr("Scene");
    kind.help = ScenePanel::tr("Pictures, method, filter, camera and light");
    kind.place = DockPlace::Left;
    kind.make = [](Workspace* workspace, QWidget* parent) -> QWidget* {
        auto* const scroll = new SceneArea(parent);
        auto* const panel = new ScenePanel(workspace, scroll);
        scroll->setWidget(panel);
        scroll->setAccessibleName(ScenePanel::tr("Scene"));
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        return scroll;
    };
    return kind;
}

}  // namespace reliefui

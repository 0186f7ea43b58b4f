// The scenario's controls: surface, scene, camera, light and picture size. The pictures and the method's options have
// panels of their own.
#pragma once

#include <vector>

#include <QWidget>

#include "panes/pane.h"
#include "workspace/workspace.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace reliefui {

class NumberControl;
class OptionsForm;

// Sets one number of the scenario; shared by sliders, boxes and tests.
void changeNumber(Workspace& workspace, const std::string& name, double value, bool live);

// A common view: its angle to the plane of the relief, in degrees, and its distance.
struct ViewPreset {
    const char* name = "";  // tr() in "reliefui::ScenePanel"
    double angle = 0;
    double distance = 1;
};
const std::vector<ViewPreset>& viewPresets();
relief::Camera presetCamera(const ViewPreset& preset, relief::SceneKind scene);

// Creates a control for this number that follows the workspace and changes it.
NumberControl* makeNumberControl(Workspace* workspace, const std::string& name, QWidget* parent);

class ScenePanel : public QWidget {
    Q_OBJECT
  public:
    explicit ScenePanel(Workspace* workspace, QWidget* parent = nullptr);

  private:
    QFormLayout* addGroup(QVBoxLayout* column, const QString& title);
    void addNumbers(QFormLayout* form, const std::vector<const char*>& names);
    QComboBox* addChoice(QFormLayout* form, const QString& title, const QString& objectName, const QString& help,
                         const std::vector<std::string>& names);
    void addSurface(QFormLayout* form);
    void addViews(QFormLayout* form);
    void addDefaults(QFormLayout* form);
    void addShadows(QFormLayout* form);
    void addMapping(QFormLayout* form);
    void addMethod(QFormLayout* form);
    void refresh();
    void refreshMethod();

    Workspace* workspace_;
    QComboBox* surface_ = nullptr;
    QComboBox* address_ = nullptr;
    QComboBox* scene_ = nullptr;
    QComboBox* mapping_ = nullptr;
    QCheckBox* shadows_ = nullptr;
    QToolButton* defaults_ = nullptr;
    OptionsForm* options_ = nullptr;
    QLabel* help_ = nullptr;       // description of the method
    QLabel* guarantee_ = nullptr;  // the method's guarantee, its conditions, and the memory used by its maps
};

PaneKind scenePane();

}  // namespace reliefui

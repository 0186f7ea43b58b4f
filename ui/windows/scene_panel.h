// The controls of the scenario: surface, scene, camera, light, size of the picture; the pictures and the method's
// options have boxes of their own.
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

// Turns one number of the scenario; what a slider, a box or a test does.
void changeNumber(Workspace& workspace, const std::string& name, double value, bool live);

// A view that is asked for often: how steeply it looks at the relief's plane, degrees, and from how far.
struct ViewPreset {
    const char* name = "";  // tr() in "reliefui::ScenePanel"
    double angle = 0;
    double distance = 1;
};
const std::vector<ViewPreset>& viewPresets();
relief::Camera presetCamera(const ViewPreset& preset, relief::SceneKind scene);

// A control of that number that follows the workspace and changes it.
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
    QLabel* help_ = nullptr;       // of the method
    QLabel* guarantee_ = nullptr;  // what it promises, where, and what it keeps in memory
};

PaneKind scenePane();

}  // namespace reliefui

// What is changed most, always in sight: the method, the filter, the depth of the relief.
#pragma once

#include <QToolBar>

#include "workspace/workspace.h"

class QComboBox;

namespace reliefui {

class NumberControl;

class TopBar : public QToolBar {
    Q_OBJECT
  public:
    // The actions come from the window's menus.
    TopBar(Workspace* workspace, QAction* open, const QList<QAction*>& others, QWidget* parent = nullptr);

    QComboBox* method() { return method_; }
    QComboBox* filter() { return filter_; }
    NumberControl* depth() { return depth_; }

  private:
    void addLabeled(const QString& label, QWidget* control);
    // Those that search for the relief, or the others (shading only, a mesh), under a heading if it has one.
    void addMethods(bool tracers, const QString& group);
    void makeMethod();
    void makeFilter();
    void refresh();

    Workspace* workspace_;
    QComboBox* method_;
    QComboBox* filter_;
    NumberControl* depth_;
};

}  // namespace reliefui

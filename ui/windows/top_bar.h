// The most frequently used controls, always visible: the method, the filter, the depth of the relief.
#pragma once

#include <QToolBar>

#include "workspace/workspace.h"

class QComboBox;

namespace reliefui {

class NumberControl;

class TopBar : public QToolBar {
    Q_OBJECT
  public:
    // The actions are created by the window's menus.
    TopBar(Workspace* workspace, QAction* open, const QList<QAction*>& others, QWidget* parent = nullptr);

    QComboBox* method() { return method_; }
    QComboBox* filter() { return filter_; }
    NumberControl* depth() { return depth_; }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void addLabeled(const QString& label, QWidget* control);
    void makeMethod();
    void makeFilter();
    void refresh();

    Workspace* workspace_;
    QComboBox* method_;
    QComboBox* filter_;
    NumberControl* depth_;
};

}  // namespace reliefui

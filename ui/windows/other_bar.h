// Shown while files of another program's tracer are open: chooses one of its rays, and whether the panes show its steps
// or those of the method.
#pragma once

#include <QWidget>

#include "workspace/workspace.h"

class QComboBox;
class QLabel;
class QSpinBox;

namespace reliefui {

class OtherBar : public QWidget {
    Q_OBJECT
  public:
    explicit OtherBar(Workspace* workspace, QWidget* parent = nullptr);

    // Opens the two files. An invalid file is refused with its line number, and nothing changes.
    void open(const QString& rays, const QString& steps);

  public slots:
    void close();

  private:
    void refresh();
    void change(const relief::OtherTracer& other, const QString& what);

    Workspace* workspace_;
    QLabel* file_;
    QSpinBox* ray_;
    QLabel* count_;
    QComboBox* stepsOf_;
};

}  // namespace reliefui

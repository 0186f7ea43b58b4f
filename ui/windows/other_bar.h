// Somebody else's tracer is open: which of its rays is looked at, and whose steps the panes show.
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

    // The files; a bad one is refused with its line, and everything stays as it was.
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
    QComboBox* whose_;
};

}  // namespace reliefui

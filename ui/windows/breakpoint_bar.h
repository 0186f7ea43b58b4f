// Where stepping stops: a row of conditions, each of which can be set off or taken away, and what adds one.
#pragma once

#include <QWidget>

#include "workspace/workspace.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QSpinBox;

namespace reliefui {

class BreakpointBar : public QWidget {
    Q_OBJECT
  public:
    explicit BreakpointBar(Workspace* workspace, QWidget* parent = nullptr);

    // What the fields describe.
    relief::Breakpoint edited() const;

  public slots:
    void add();
    // At the texel of the chosen step: set, or taken away where there is one.
    void toggleHere();

  private:
    QSpinBox* addNumber(const char* name, const QString& prefix, const QString& help, int low, int high);
    void showFields();
    void refresh();  // the conditions there are
    void addChip(std::size_t number, const relief::Breakpoint& breakpoint);
    void remove(std::size_t number);
    void setOn(std::size_t number, bool on);

    Workspace* workspace_;
    QHBoxLayout* row_;
    QComboBox* kind_;
    QSpinBox* level_ = nullptr;
    QSpinBox* i_ = nullptr;
    QSpinBox* j_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QWidget* chips_ = nullptr;
    std::vector<relief::Breakpoint> shown_;
};

// In the language of the window.
QString breakpointText(const relief::Breakpoint& breakpoint, relief::Language language);

}  // namespace reliefui

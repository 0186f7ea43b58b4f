// Breakpoints: a row of conditions at which stepping stops. Each can be disabled or removed; the fields at the end add
// one.
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

    // The breakpoint that the fields currently describe.
    relief::Breakpoint edited() const;

  public slots:
    void add();
    // Adds a breakpoint at the texel of the chosen step, or removes the one that is there.
    void toggleHere();

  private:
    QSpinBox* addNumber(const char* name, const QString& prefix, const QString& help, int low, int high);
    void showFields();
    void refresh();  // shows the scenario's breakpoints
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

// Description of a breakpoint in the given language.
QString breakpointText(const relief::Breakpoint& breakpoint, relief::Language language);

}  // namespace reliefui

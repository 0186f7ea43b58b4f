// Breakpoints: fields that add one, and the list of all. Each entry says how often the chosen ray meets it, and can be
// disabled or removed.
#pragma once

#include <QWidget>

#include "workspace/workspace.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLineEdit;
class QSpinBox;

namespace reliefui {

class BreakpointBar : public QWidget {
    Q_OBJECT
  public:
    explicit BreakpointBar(Workspace* workspace, QWidget* parent = nullptr);

    // The breakpoint that the fields currently describe.
    relief::Breakpoint edited() const;

  public slots:
    // Adds the edited breakpoint; a wrong condition is refused with a message.
    void add();
    // Adds a breakpoint at the texel of the chosen step, or removes the one that is there. Does nothing without steps.
    void toggleHere();

  private:
    QSpinBox* addNumber(const char* name, const QString& prefix, const QString& help, int low, int high);
    void makeCondition();
    void showFields();
    void refresh();  // shows the scenario's breakpoints
    // What an entry of the list shows.
    struct Chip {
        QString text, help;
        bool on = true;
        bool operator==(const Chip&) const = default;
    };
    Chip chipOf(const relief::Breakpoint& breakpoint) const;
    void add(const relief::Breakpoint& added);
    void addChip(std::size_t number, const Chip& chip, const QString& name);
    void remove(std::size_t number);
    void setOn(std::size_t number, bool on);

    Workspace* workspace_;
    QHBoxLayout* row_ = nullptr;
    QComboBox* kind_;
    QSpinBox* level_ = nullptr;
    QSpinBox* i_ = nullptr;
    QSpinBox* j_ = nullptr;
    QDoubleSpinBox* height_ = nullptr;
    QLineEdit* condition_ = nullptr;
    QSpinBox* ignore_ = nullptr;
    QWidget* chips_ = nullptr;
    std::vector<Chip> shown_;
};

// Description of a breakpoint in the given language.
QString breakpointText(const relief::Breakpoint& breakpoint, relief::Language language);

}  // namespace reliefui

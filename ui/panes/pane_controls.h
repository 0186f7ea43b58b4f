// The controls in the bars of panes. Their help is their tool tip, and what screen readers call them.
#pragma once

#include <QString>

class QComboBox;
class QLayout;
class QToolButton;

namespace reliefui {

QToolButton* addToolButton(QLayout* bar, const QString& text, const QString& help, bool checkable = false);
// name: of the object.
QComboBox* addChooser(QLayout* bar, const char* name, const QString& help);

}  // namespace reliefui

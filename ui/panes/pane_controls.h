// Controls for the bars of panes. The help text becomes tool tip and accessible name.
#pragma once

#include <QString>

class QComboBox;
class QLayout;
class QToolButton;

namespace reliefui {

QToolButton* addToolButton(QLayout* bar, const QString& text, const QString& help, bool checkable = false);
// name: object name.
QComboBox* addChooser(QLayout* bar, const char* name, const QString& help);

}  // namespace reliefui

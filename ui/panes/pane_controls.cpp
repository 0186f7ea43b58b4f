#include "panes/pane_controls.h"

#include <QLayout>
#include <QToolButton>

#include "panes/name_box.h"

namespace reliefui {

QToolButton* addToolButton(QLayout* bar, const QString& text, const QString& help, bool checkable) {
    auto* const button = new QToolButton(bar->parentWidget());
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setCheckable(checkable);
    button->setAutoRaise(true);
    bar->addWidget(button);
    return button;
}

QComboBox* addChooser(QLayout* bar, const char* name, const QString& help) {
    auto* const box = new NameBox(bar->parentWidget());
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(help);
    box->setAccessibleName(help);
    bar->addWidget(box);
    return box;
}

}  // namespace reliefui

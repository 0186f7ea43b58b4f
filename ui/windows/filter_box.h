// Choice of the filter and its options, generated from its description; for `supersample` also the number of samples
// and the pixel model.
#pragma once

#include <QWidget>

#include "workspace/workspace.h"

class QLabel;

namespace reliefui {

class OptionsForm;

class FilterBox : public QWidget {
    Q_OBJECT
  public:
    explicit FilterBox(Workspace* workspace, QWidget* parent = nullptr);

  private:
    void refresh();
    void change(const QString& name, const QString& text, bool live);

    Workspace* workspace_;
    QLabel* help_;
    OptionsForm* options_;
};

}  // namespace reliefui

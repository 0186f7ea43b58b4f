// The options of a method as controls, made from their descriptions: any method's, also one added later.
#pragma once

#include <QWidget>

#include "relief/describe.h"

class QFormLayout;

namespace reliefui {

class OptionsForm : public QWidget {
    Q_OBJECT
  public:
    explicit OptionsForm(QWidget* parent = nullptr);

    // The controls of `method`, holding the values of `choice` where it gives them.
    void show(const relief::MethodDescription& method, const relief::MethodChoice& choice);

  signals:
    void changed(const QString& name, const QString& text, bool live);
    void settled();

  private:
    void rebuild(const relief::MethodDescription& method);
    void addControl(const relief::OptionDescription& option);
    void setText(const relief::OptionDescription& option, const std::string& text);

    QFormLayout* form_;
    std::string shown_;
};

}  // namespace reliefui

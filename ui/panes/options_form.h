// The options of a method as controls, made from their descriptions: any method's, also one added later. Where a method
// has another one inside it, that one's options stand indented below the chooser.
#pragma once

#include <string>
#include <vector>

#include <QWidget>

#include "relief/describe.h"

class QFormLayout;

namespace reliefui {

class NumberControl;

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
    // An option as the choice names it ("inner.layers"), and its default.
    struct Control {
        std::string key;
        relief::OptionDescription option;
        std::string preset;
        int depth = 0;
    };

    static void collect(const relief::MethodDescription& method, const relief::OptionValues& values,
                        const std::string& prefix, int depth, std::vector<Control>& out);
    void rebuild(const std::vector<Control>& controls);
    void addControl(const Control& control);
    void addWords(const Control& control, NumberControl* number);
    void setText(const Control& control, const std::string& text);

    QFormLayout* form_;
    std::string shown_;  // which method, and which inside it
};

}  // namespace reliefui

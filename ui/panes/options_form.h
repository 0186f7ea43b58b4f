// Controls for the options of a method, generated from their descriptions, also for methods added later. If a method
// contains another one, the inner method's options are indented below the chooser.
#pragma once

#include <map>
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

    // Shows the options of `method` with the values of `choice`, or their defaults.
    void show(const relief::MethodDescription& method, const relief::MethodChoice& choice);

  signals:
    void changed(const QString& name, const QString& text, bool live);
    void editFinished();

  private:
    // An option's key in the choice ("inner.layers"), and its default.
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
    std::string shown_;                   // identifies the method shown, including nested ones
    std::map<QString, QString> choices_;  // the entries of the lists as shown last, by the key of the option
};

}  // namespace reliefui

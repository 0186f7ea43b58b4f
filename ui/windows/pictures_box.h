// Which pictures the scene is made of: height, colour, normals, or a procedural relief.
#pragma once

#include <vector>

#include <QWidget>

#include "workspace/workspace.h"

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace reliefui {

// Asks for a picture file; empty if nothing was chosen.
QString askForPicture(QWidget* parent, const QString& title, const QString& current);

class PicturesBox : public QWidget {
    Q_OBJECT
  public:
    explicit PicturesBox(Workspace* workspace, QWidget* parent = nullptr);

  private:
    // A picture's role, its file name, and what can be done with it.
    struct Row {
        QLabel* name = nullptr;
        QToolButton* clear = nullptr;
        std::string relief::Pictures::*member = nullptr;
    };

    // source: of its title.
    void addRow(QVBoxLayout* column, const char* source, std::string relief::Pictures::*member,
                const QString& objectName);
    void addRecipe(QVBoxLayout* column);
    void makeRecipe();
    void refresh();

    Workspace* workspace_;
    QLabel* folder_ = nullptr;
    std::vector<Row> rows_;
    QComboBox* recipe_ = nullptr;
    QSpinBox* size_ = nullptr;
    QSpinBox* seed_ = nullptr;
};

}  // namespace reliefui

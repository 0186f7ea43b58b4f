// Chooses the pictures of the scene: height, colour and normals, or a procedural relief.
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

class SeedBox;

// Opens a file dialog for a picture; returns its path, or an empty string if the user cancelled.
QString askForPicture(QWidget* parent, const QString& title, const QString& current);

class PicturesBox : public QWidget {
    Q_OBJECT
  public:
    explicit PicturesBox(Workspace* workspace, QWidget* parent = nullptr);

  private:
    // One picture: its role, its file name, and buttons for it.
    struct Row {
        QLabel* name = nullptr;
        QToolButton* clear = nullptr;
        std::string relief::Pictures::*member = nullptr;
    };

    // source: untranslated title.
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
    SeedBox* seed_ = nullptr;
};

}  // namespace reliefui

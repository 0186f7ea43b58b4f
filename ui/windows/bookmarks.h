// Bookmarks of the scenario: a menu to go to them, and a dialog to rename and remove them.
#pragma once

#include <QDialog>
#include <QObject>

#include "workspace/workspace.h"

class QListWidget;
class QMenu;

namespace reliefui {

// Refills `menu` each time it opens, after the actions that it already contains.
class BookmarkMenu : public QObject {
    Q_OBJECT
  public:
    BookmarkMenu(Workspace* workspace, QMenu* menu, QObject* parent = nullptr);

  public slots:
    void addHere();  // adds the chosen pixel under a generated name
    void next();     // goes to the bookmark after the current one; the last is followed by the first
    void fill();

  private:
    Workspace* workspace_;
    QMenu* menu_;
    int fixed_;             // number of permanent actions at the top of the menu
    std::size_t last_ = 0;  // number of the bookmark that next() went to last
};

class BookmarkDialog : public QDialog {
    Q_OBJECT
  public:
    explicit BookmarkDialog(Workspace* workspace, QWidget* parent = nullptr);

    QListWidget* list() { return list_; }

  public slots:
    void go();
    void remove();

  private:
    void refresh();
    void rename();

    Workspace* workspace_;
    QListWidget* list_;
    bool filling_ = false;
};

}  // namespace reliefui

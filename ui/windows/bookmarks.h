// Bookmarks of the scenario: a menu that goes to them, and a dialog that names and removes them.
#pragma once

#include <QDialog>
#include <QObject>

#include "workspace/workspace.h"

class QListWidget;
class QMenu;

namespace reliefui {

// Fills `menu` each time it opens, after the actions that are there already.
class BookmarkMenu : public QObject {
    Q_OBJECT
  public:
    BookmarkMenu(Workspace* workspace, QMenu* menu, QObject* parent = nullptr);

  public slots:
    void addHere();  // the chosen pixel, with a name of its own
    void next();     // after the one where we are, round and round
    void fill();

  private:
    Workspace* workspace_;
    QMenu* menu_;
    int fixed_;  // actions that stay
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

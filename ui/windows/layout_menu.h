// The user's own layouts: saved under a name, chosen and deleted in a menu, and stored in the settings.
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace reliefui {

class MainWindow;

// Refills `menu` each time it opens, after the actions that it already contains.
class LayoutMenu : public QObject {
    Q_OBJECT
  public:
    LayoutMenu(MainWindow* window, QMenu* menu);

    static QStringList names();
    void save(const QString& name);
    void choose(const QString& name);
    void remove(const QString& name);

  public slots:
    void askName();

  private:
    void fill();

    MainWindow* window_;
    QMenu* menu_;
    int fixed_ = 0;  // number of permanent actions at the top of the menu
};

}  // namespace reliefui

// Layouts of one's own: saved under a name, chosen, deleted; kept in the settings.
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace reliefui {

class MainWindow;

// Fills `menu` each time it opens, after the actions that are there already.
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
    int fixed_ = 0;  // actions that stay
};

}  // namespace reliefui

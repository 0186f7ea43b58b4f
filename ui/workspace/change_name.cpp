#include "workspace/change_name.h"

#include <utility>

#include <QHash>

namespace reliefui {

namespace {

// One table for all workspaces: a name means the same in each.
QHash<QString, std::function<QString()>>& names() {
    static QHash<QString, std::function<QString()>> all;
    return all;
}

}  // namespace

QString changeName(std::function<QString()> translate) {
    QString name = translate();
    names().insert(name, std::move(translate));
    return name;
}

QString translatedChangeName(const QString& name) {
    const auto at = names().constFind(name);
    return at == names().constEnd() ? name : (*at)();
}

}  // namespace reliefui

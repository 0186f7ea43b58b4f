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

QString changeName(std::function<QString()> said) {
    QString name = said();
    names().insert(name, std::move(said));
    return name;
}

QString saidAgain(const QString& name) {
    const auto at = names().constFind(name);
    return at == names().constEnd() ? name : (*at)();
}

}  // namespace reliefui

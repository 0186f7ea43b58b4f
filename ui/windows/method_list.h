// The lists of methods, filters and procedural reliefs: each entry shows the name in words, its source and, in small
// type, the identifier used in commands and files.
#pragma once

class QComboBox;

namespace reliefui {

// Fills the list; the data of an entry is the identifier. Methods that search the relief come first, the others follow
// below a heading.
void fillMethods(QComboBox* list);
// The same for filters.
void fillFilters(QComboBox* list);
// Adds the procedural reliefs below the entries that the list has.
void addRecipes(QComboBox* list);

}  // namespace reliefui

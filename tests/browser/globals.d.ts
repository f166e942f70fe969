// Declarations that the converter puts before the player's files.
declare const PROJECT: ProjectData;

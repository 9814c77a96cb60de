extern const char earlyName[];
extern const char earlyService[];

const char earlyName[]    = "Second";
const char earlyService[] = "Second.Ear.Text.O";

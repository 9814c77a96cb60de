extern const char earlyName[];
extern const char earlyService[];

const char earlyName[]    = "First";
const char earlyService[] = "First.Ear.Text.O";

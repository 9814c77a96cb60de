/* What both controllers do in an iteration; TIME_STEP is how long it lasts. */
#define TIME_STEP 32

void timing_reset(void);
void timing_iteration(void);
void timing_die(void);

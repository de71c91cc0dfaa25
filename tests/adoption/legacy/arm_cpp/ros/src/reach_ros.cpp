/* protected region user thread begin */
int priority = 3;
/* protected region user thread end */

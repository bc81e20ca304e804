// Runs before the page's large script has come: the stream connects and the first picture is decoded meanwhile.
import {linkWorker} from './link/early_worker';

linkWorker();

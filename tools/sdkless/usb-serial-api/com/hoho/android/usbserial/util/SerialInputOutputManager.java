package com.hoho.android.usbserial.util;

import com.hoho.android.usbserial.driver.UsbSerialPort;

public class SerialInputOutputManager {
    public interface Listener {
        void onNewData(byte[] data);

        void onRunError(Exception e);
    }

    public SerialInputOutputManager(UsbSerialPort serialPort, Listener listener) {}

    public void setReadTimeout(int timeout) {}

    public void start() {}

    public void stop() {}
}

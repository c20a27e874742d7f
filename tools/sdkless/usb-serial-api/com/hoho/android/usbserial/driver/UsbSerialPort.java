package com.hoho.android.usbserial.driver;

import android.hardware.usb.UsbDeviceConnection;
import java.io.Closeable;
import java.io.IOException;

public interface UsbSerialPort extends Closeable {
    int PARITY_NONE = 0;
    int STOPBITS_1 = 1;

    void open(UsbDeviceConnection connection) throws IOException;

    @Override
    void close() throws IOException;

    void setParameters(int baudRate, int dataBits, int stopBits, int parity) throws IOException;

    void setDTR(boolean value) throws IOException;

    void setRTS(boolean value) throws IOException;
}
